/** The live view: simulations that a page on this machine watches and commands. */
package org.hificamsim.presentation.view;
