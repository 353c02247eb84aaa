/** Real places: walls from drawings and maps, floor plans, where cameras could stand. */
package org.hificamsim.tracks.place;
