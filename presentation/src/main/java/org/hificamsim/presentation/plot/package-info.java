/** Draws panels of lines, points and bars under one legend, and writes pictures in files. */
package org.hificamsim.presentation.plot;
