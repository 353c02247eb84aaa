/** Pages: one self-contained HTML file that shows a run or a comparison. */
package org.hificamsim.presentation.report;
