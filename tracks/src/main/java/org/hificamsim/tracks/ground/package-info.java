/** Conversion of positions in files to metres on flat ground. */
package org.hificamsim.tracks.ground;
