/**
 * Statistics of scores over several scenarios and seeds: aggregates, profiles and comparisons of
 * policies, each with its interval (Agarwal et al., Deep Reinforcement Learning at the Edge of the
 * Statistical Precipice, NeurIPS 2021).
 */
package org.hificamsim.runs.statistics;
