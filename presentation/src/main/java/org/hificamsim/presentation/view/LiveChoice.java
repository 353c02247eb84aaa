package org.hificamsim.presentation.view;

/**
 * What one of the simulations runs under.
 *
 * @param detection name of the model
 * @param threshold in [0, 1]; null for the scenario's, else the model's
 * @param policy name and options
 */
public record LiveChoice(String detection, Double threshold, String policy) {}
