/** A camera as a member of the network: its state, and what messages do to it. */
package org.hificamsim.network.agent;
