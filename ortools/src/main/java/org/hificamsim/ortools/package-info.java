/** The exact method of {@code place}: CP-SAT of OR-Tools. */
package org.hificamsim.ortools;
