/** Real places: walls from drawings and maps, floor plans, and drafts of cameras. */
package org.hificamsim.tracks.place;
