/** The formats of recordings, each a class with a name. */
package org.hificamsim.tracks.format;
