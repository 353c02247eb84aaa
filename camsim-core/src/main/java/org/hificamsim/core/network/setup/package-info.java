/** What a run of the network is asked to be: settings, quirks, and each camera's setup. */
package org.hificamsim.core.network.setup;
