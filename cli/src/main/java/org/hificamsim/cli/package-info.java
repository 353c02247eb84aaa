/** The command line: reads options, checks them all before anything is written, reports faults. */
package org.hificamsim.cli;
