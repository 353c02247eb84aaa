/** The figures that a comparison's results are drawn as. */
package org.hificamsim.presentation.figures;
