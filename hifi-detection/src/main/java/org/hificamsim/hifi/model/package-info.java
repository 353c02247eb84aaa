/** Detection models as data: the catalogue of published ones, users' files, and their names. */
package org.hificamsim.hifi.model;
