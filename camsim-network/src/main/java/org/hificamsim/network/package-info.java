/** CamSim's network of cameras: its settings, its start from a scenario, and its step. */
package org.hificamsim.network;
