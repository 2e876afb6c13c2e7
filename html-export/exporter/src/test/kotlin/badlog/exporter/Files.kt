package badlog.exporter

import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

internal const val BAG = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]}," +
    "{\"name\":\"Speed\",\"unit\":\"m/s\",\"attrs\":[]}]," +
    "\"values\":[{\"name\":\"Event Name\",\"value\":\"OHCL\"},{\"name\":\"Match Number\",\"value\":\"42\"}]}\n" +
    "Time,Speed\n0.0000,1.0000\n0.0200,2.0000\n"

/** The same bag after a loss of power in its last row. */
internal val CUT_BAG = BAG.dropLast(9)

/** Returns the names of all files in the folder, including hidden ones. */
internal fun Path.names(): List<String> = listDirectoryEntries().map { it.name }.sorted()
