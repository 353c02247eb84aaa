/** CamSim's studies: which networks give how much utility for how many messages. */
package org.hificamsim.network.study;
