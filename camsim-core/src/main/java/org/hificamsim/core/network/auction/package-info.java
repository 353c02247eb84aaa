/** The auctions by which targets change hands. */
package org.hificamsim.core.network.auction;
