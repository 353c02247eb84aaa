/** The formats that recordings come in, one class each, by name. */
package org.hificamsim.tracks.format;
