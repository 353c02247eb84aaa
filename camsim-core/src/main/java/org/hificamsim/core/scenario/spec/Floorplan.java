package org.hificamsim.core.scenario.spec;

/**
 * A picture of the place, drawn under the field.
 *
 * @param file path of a PNG or JPEG, from the scenario's folder
 * @param area what the picture shows, metres
 */
public record Floorplan(String file, Field area) {}
