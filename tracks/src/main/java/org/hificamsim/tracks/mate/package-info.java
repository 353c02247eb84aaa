/** MATE, the multi-agent tracking environment: recorded episodes, and its arena. */
package org.hificamsim.tracks.mate;
