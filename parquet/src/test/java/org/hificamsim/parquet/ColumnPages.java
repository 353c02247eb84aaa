package org.hificamsim.parquet;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.zip.GZIPInputStream;
import org.apache.parquet.bytes.BytesInput;
import org.apache.parquet.column.Encoding;
import org.apache.parquet.column.page.DataPage;
import org.apache.parquet.column.page.DataPageV2;
import org.apache.parquet.column.page.DictionaryPage;
import org.apache.parquet.column.page.PageReader;
import org.apache.parquet.format.DataPageHeaderV2;
import org.apache.parquet.format.PageHeader;
import org.apache.parquet.format.PageType;
import org.apache.parquet.format.Util;

/** The pages of a column in a row group: its dictionary, if it has one, and data of version 2. */
final class ColumnPages implements PageReader {
  private final ByteArrayInputStream in;
  private final long values;
  private final DictionaryPage dictionary;
  private PageHeader next;

  ColumnPages(byte[] bytes, long values) throws IOException {
    this.in = new ByteArrayInputStream(bytes);
    this.values = values;
    advance();
    dictionary = next.getType() == PageType.DICTIONARY_PAGE ? dictionary(next) : null;
  }

  private void advance() throws IOException {
    next = in.available() == 0 ? null : Util.readPageHeader(in);
  }

  private DictionaryPage dictionary(PageHeader header) throws IOException {
    DictionaryPage page =
        new DictionaryPage(
            unzipped(header.getCompressed_page_size()),
            header.getDictionary_page_header().getNum_values(),
            Encoding.valueOf(header.getDictionary_page_header().getEncoding().name()));
    advance();
    return page;
  }

  @Override
  public DictionaryPage readDictionaryPage() {
    return dictionary;
  }

  @Override
  public long getTotalValueCount() {
    return values;
  }

  @Override
  public DataPage readPage() {
    try {
      DataPage page = next == null ? null : page(next, next.getData_page_header_v2());
      advance();
      return page;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private DataPage page(PageHeader page, DataPageHeaderV2 header) throws IOException {
    BytesInput repetitions = bytes(header.getRepetition_levels_byte_length());
    BytesInput definitions = bytes(header.getDefinition_levels_byte_length());
    int size =
        page.getCompressed_page_size() - Math.toIntExact(repetitions.size() + definitions.size());
    return DataPageV2.uncompressed(
        header.getNum_rows(),
        header.getNum_nulls(),
        header.getNum_values(),
        repetitions,
        definitions,
        Encoding.valueOf(header.getEncoding().name()),
        header.isIs_compressed() ? unzipped(size) : bytes(size),
        null);
  }

  private BytesInput bytes(int count) throws IOException {
    return BytesInput.from(in.readNBytes(count));
  }

  private BytesInput unzipped(int count) throws IOException {
    byte[] zipped = in.readNBytes(count);
    try (GZIPInputStream unzipped = new GZIPInputStream(new ByteArrayInputStream(zipped))) {
      return BytesInput.from(unzipped.readAllBytes());
    }
  }
}
