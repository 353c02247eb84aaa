/** The auctions by which targets change hands. */
package org.hificamsim.network.auction;
