/** Pages: self-contained HTML files that show a run or a comparison. */
package org.hificamsim.presentation.report;
