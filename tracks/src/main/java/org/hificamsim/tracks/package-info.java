/** Recordings of real movement, imported as scenarios: samples sorted by target, gaps, figures. */
package org.hificamsim.tracks;
