/** From what files measure positions in to metres on flat ground. */
package org.hificamsim.tracks.ground;
