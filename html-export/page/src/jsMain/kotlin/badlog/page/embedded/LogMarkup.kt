package badlog.page.embedded

import badlog.page.dom.element
import badlog.page.dom.json
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Returns the markup for the log in [files], the same as the exporter's. It consists of the log's gzip stream in base64, and the facts
 * about it. A gzipped file is embedded unchanged.
 *
 * @param version the version of badlog that wrote this page.
 */
internal fun markupOf(files: List<File>, version: String): Promise<Blob> {
    val whole = Blob(files.toTypedArray())
    return bytesOf(whole, 0.0, GZIP.size.toDouble()).then { head ->
        val facts = json("name" to files[0].name, "version" to version)
        files.getOrNull(1)?.let { second ->
            facts.second = second.name
            facts.firstBytes = files[0].size
        }
        if (head.contentEquals(GZIP)) asItIs(whole, facts) else gzipped(whole, facts)
    }.unsafeCast<Promise<Blob>>()
}

private fun asItIs(gzip: Blob, facts: dynamic): Promise<Blob> = bytesOf(gzip, 0.0, gzip.size.toDouble()).then { bytes ->
    var inflated = 0.0
    val inflater = Inflater(bytes) { inflated += it.size }
    inflater.run()
    facts.original = "gzip"
    facts.inflatedBytes = inflated
    facts.cut = inflater.isCut
    markupOf(gzip, facts)
}.unsafeCast<Promise<Blob>>()

private fun gzipped(file: Blob, facts: dynamic): Promise<Blob> = packed(file).then { gzip ->
    facts.original = "raw"
    facts.inflatedBytes = file.size
    markupOf(gzip, facts)
}.unsafeCast<Promise<Blob>>()

private fun markupOf(gzip: Blob, facts: dynamic): Promise<Blob> {
    val sums = LineSums()
    return scriptOf(gzip, "id", "recording", facts.name as String, sums).then { script ->
        facts.crc32 = sums.all.toTypedArray()
        // A file name must not end the script.
        val text = JSON.stringify(facts.unsafeCast<Any>()).replace("<", "\\u003c")
        Blob(arrayOf<dynamic>(script, "<script type=\"application/json\" id=\"about\">$text$END\n"))
    }
}

/** Returns the markup for [file], a file of a compared log. */
internal fun markupOfCompared(file: File): Promise<Blob> =
    packed(file).then { scriptOf(it, "class", "compared", file.name, LineSums()) }.unsafeCast<Promise<Blob>>()

/** Returns the script that holds [gzip], the file [name]; its checksums are added to [sums]. */
private fun scriptOf(gzip: Blob, attribute: String, value: String, name: String, sums: LineSums): Promise<Blob> {
    val carrier = element("script")
    carrier.setAttribute("type", "application/octet-stream")
    carrier.setAttribute(attribute, value)
    carrier.setAttribute("data-name", name)
    val markup = BlobParts()
    markup.add(carrier.outerHTML.removeSuffix(END))
    fun addFrom(from: Double): Promise<Unit> = bytesOf(gzip, from, from + PIECE).then { bytes ->
        val isLast = bytes.size < PIECE
        sums.add(bytes, isLast)
        markup.add(base64(bytes))
        if (isLast) Unit else addFrom(from + PIECE)
    }.unsafeCast<Promise<Unit>>()
    return addFrom(0.0).then {
        markup.add("$END\n")
        markup.toBlob()
    }
}
