/**
 * Upper bounds with global knowledge: the exactly best configurations of each step and of a run.
 */
package org.hificamsim.agents.optimal;
