package org.hificamsim.runs.compare;

import java.io.Serializable;

/**
 * One run of a comparison.
 *
 * @param plan the index of the plan in the list of plans
 * @param repeat the number of the repeat, from 0
 */
public record RunTask(int plan, int repeat) implements Serializable {}
