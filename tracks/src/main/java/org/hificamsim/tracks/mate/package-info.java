/** Recorded episodes of MATE, the multi-agent tracking environment. */
package org.hificamsim.tracks.mate;
