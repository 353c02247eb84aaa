/** The experiment of docs/camsim-network.md. */
package org.hificamsim.reproduction.network;
