/**
 * Frozen tasks that others can enter: what they are, results with their actions, checks, places.
 */
package org.hificamsim.runs.benchmark;
