/** The statistics of CamSim's files: the value of each step, and the overlap of fields of view. */
package org.hificamsim.network.statistics;
