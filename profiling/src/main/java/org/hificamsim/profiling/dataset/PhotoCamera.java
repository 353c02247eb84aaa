package org.hificamsim.profiling.dataset;

/**
 * The camera that took the pictures of a data set ({@code camera.json}).
 *
 * @param sensorWidth metres
 * @param sensorHeight metres
 * @param width of every picture, pixels
 * @param height of every picture, pixels
 */
public record PhotoCamera(double sensorWidth, double sensorHeight, int width, int height) {}
