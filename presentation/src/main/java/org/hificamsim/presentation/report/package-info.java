/** Makes pages, which are HTML files that show a run or a comparison and need no other file. */
package org.hificamsim.presentation.report;
