/** The figures of CamSim about a network, per camera and per step. */
package org.hificamsim.network.statistics;
