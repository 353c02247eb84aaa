/** Strict reading of JSON files in which every fault is reported with its line and column. */
package org.hificamsim.hifi.json;
