package org.hificamsim.tracks.format;

/**
 * A sign that a file is read in the wrong way, so that its samples are useless.
 *
 * @param problem the finding and its likely cause
 * @param cure the remedy, with the names of settings
 */
public record Doubt(String problem, String cure) {}
