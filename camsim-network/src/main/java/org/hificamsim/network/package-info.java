/** Cameras as a network: vision graph, messages, auctions and handovers, after CamSim. */
package org.hificamsim.network;
