/** Upper bounds with global knowledge: the exactly best configuration of each step. */
package org.hificamsim.agents.optimal;
