/** The figures that show the results of a comparison. */
package org.hificamsim.presentation.figures;
