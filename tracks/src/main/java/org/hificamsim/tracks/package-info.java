/** Imports recordings of real movement as scenarios. */
package org.hificamsim.tracks;
