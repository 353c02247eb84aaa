/** Recordings of runs, frame by frame, for pages, pictures and the live view. */
package org.hificamsim.presentation.replay;
