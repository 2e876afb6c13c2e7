package badlog.release

import java.io.File

/** Writes the bill of materials. The arguments: its file, the list of libraries, the time of the commit, the version, Java's vendor and version. */
fun main(arguments: Array<String>) {
    val (bill, list, seconds, version, vendor) = arguments
    val libraries = shippedLibraries(File(list).readLines())
    File(bill).writeText(BillOfMaterials(version, seconds.toLong(), vendor to arguments.last(), libraries, Licenses.ofProject()).json())
}
