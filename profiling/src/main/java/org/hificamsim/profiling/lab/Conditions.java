package org.hificamsim.profiling.lab;

/**
 * What a picture was taken under, for the table.
 *
 * @param aperture the f-number
 * @param distortion k of {@link RadialDistortion}
 * @param light brightness; 1 is the laboratory's usual one
 */
record Conditions(double aperture, double distortion, double light) {}
