/** Pictures: panels of lines, points and bars, laid out under one legend, as PNG and SVG. */
package org.hificamsim.presentation.plot;
