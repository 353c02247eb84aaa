/** The live view, in which a page on this machine watches and commands simulations. */
package org.hificamsim.presentation.view;
