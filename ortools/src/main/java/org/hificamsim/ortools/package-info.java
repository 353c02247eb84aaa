/** The exact method of {@code place}: the solver SCIP from OR-Tools. */
package org.hificamsim.ortools;
