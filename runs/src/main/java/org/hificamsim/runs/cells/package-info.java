/** The cells of a field, and what cameras see of them. */
package org.hificamsim.runs.cells;
