/** The exact method of {@code place}: SCIP, of OR-Tools. */
package org.hificamsim.ortools;
