/**
 * Temporal-difference learning: a learner for each camera, with its views as actions (thesis
 * 7.4.4).
 */
package org.hificamsim.agents.temporal;
