package org.hificamsim.core.scenario.spec;

/**
 * A picture that is drawn under the field.
 *
 * @param file path of a PNG or JPEG, from the scenario's folder
 * @param area the part of the plane that the picture shows, in metres
 */
public record Floorplan(String file, Field area) {}
