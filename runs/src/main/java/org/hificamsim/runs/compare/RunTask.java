package org.hificamsim.runs.compare;

import java.io.Serializable;

/**
 * One run of a comparison.
 *
 * @param plan the plan's place in the list of plans, from 0
 * @param repeat from 0
 */
public record RunTask(int plan, int repeat) implements Serializable {}
