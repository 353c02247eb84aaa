/** A camera as a trader of targets: what it owns and knows, whom it asks, what it bids. */
package org.hificamsim.network.agent;
