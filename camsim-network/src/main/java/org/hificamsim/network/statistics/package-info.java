/** CamSim's columns: what a step was worth, and how far fields of view overlap. */
package org.hificamsim.network.statistics;
