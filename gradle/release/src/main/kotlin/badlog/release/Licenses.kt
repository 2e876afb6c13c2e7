package badlog.release

import org.w3c.dom.Element
import org.w3c.dom.Node
import java.io.File
import javax.xml.XMLConstants
import javax.xml.parsers.DocumentBuilderFactory

/**
 * The licenses of libraries, according to their POMs. The POMs of the libraries in [known] name only a parent POM, which a build does not
 * have on the disk.
 *
 * @param known licenses by group, or by group and name with a colon between.
 */
internal class Licenses(private val known: Map<String, List<String>>) {
    /**
     * Returns the names of the licenses of [library]; a user may choose one of several.
     *
     * @throws IllegalArgumentException if neither the POM nor the list names one.
     */
    fun of(library: ShippedLibrary): List<String> {
        val own = namesIn(library.description)
        if (own.isNotEmpty()) return own
        val place = "${library.group}:${library.name}"
        return requireNotNull(known[place] ?: known[library.group]) {
            "The POM of $place names no license; look it up and add it to gradle/release/src/main/resources/badlog/release/licenses.txt."
        }
    }

    companion object {
        /** Returns the licenses, completed by this project's list of known ones. */
        fun ofProject(): Licenses {
            val stream = checkNotNull(Licenses::class.java.getResourceAsStream("licenses.txt"))
            val lines = stream.use { it.readBytes().decodeToString().lines() }.filter { it.isNotBlank() && !it.startsWith('#') }
            return Licenses(lines.associate { line -> line.substringBefore(' ') to line.substringAfter(' ').split(", ") })
        }
    }
}

private fun namesIn(pom: File): List<String> {
    val factory = DocumentBuilderFactory.newInstance().apply { setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true) }
    val licenses = factory.newDocumentBuilder().parse(pom).documentElement.children("licenses").flatMap { it.children("license") }
    return licenses.flatMap { it.children("name") }.map { it.textContent.trim() }
}

private fun Element.children(name: String): List<Element> =
    generateSequence(firstChild, Node::getNextSibling).filterIsInstance<Element>().filter { it.tagName == name }.toList()
