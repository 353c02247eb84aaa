/** The command line: reads options, checks them before anything is written, and reports errors. */
package org.hificamsim.cli;
