package badlog.release

import org.cyclonedx.Version
import org.cyclonedx.generators.BomGeneratorFactory
import org.cyclonedx.model.Bom
import org.cyclonedx.model.Component
import org.cyclonedx.model.Hash
import org.cyclonedx.model.License
import org.cyclonedx.model.LicenseChoice
import org.cyclonedx.model.Metadata
import org.cyclonedx.model.Property
import org.cyclonedx.model.license.Expression
import org.cyclonedx.util.LicenseResolver
import java.security.MessageDigest
import java.util.Date
import java.util.HexFormat
import java.util.UUID

/**
 * The third-party content of one release's downloads, as a bill of materials.
 *
 * @param version the version of the release.
 * @param seconds the time of the commit, in s since 1970. It is the only time in the document, so that the same commit makes the same
 *   document.
 * @param java the vendor and version of the Java in downloads.
 */
internal class BillOfMaterials(
    private val version: String,
    private val seconds: Long,
    private val java: Pair<String, String>,
    private val libraries: List<ShippedLibrary>,
    private val licenses: Licenses,
) {
    /** Returns the document, as CycloneDX 1.6 in JSON. */
    fun json(): String {
        val bom = Bom()
        bom.metadata = Metadata().apply {
            timestamp = Date(seconds * MILLIS)
            component = Component().apply {
                type = Component.Type.APPLICATION
                name = "badlog"
                version = this@BillOfMaterials.version
                bomRef = "badlog@$version"
                licensedUnder(listOf("MIT"))
            }
        }
        bom.components = listOf(javaComponent()) + libraries.map(::componentOf)
        val content = bom.components.joinToString("\n") { "${it.bomRef} ${it.hashes.orEmpty().map(Hash::getValue)}" }
        bom.serialNumber = "urn:uuid:${UUID.nameUUIDFromBytes("badlog $version $seconds\n$content".encodeToByteArray())}"
        return BomGeneratorFactory.createJson(Version.VERSION_16, bom).toJsonString() + "\n"
    }

    private fun componentOf(library: ShippedLibrary) = Component().apply {
        type = Component.Type.LIBRARY
        group = library.group
        name = library.name
        version = library.version
        val classifier = library.classifier?.let { "?classifier=$it&type=jar" }.orEmpty()
        purl = "pkg:maven/${library.group}/${library.name}@${library.version}$classifier"
        bomRef = purl
        addHash(Hash(Hash.Algorithm.SHA_256, sha256Of(library.file.readBytes())))
        licensedUnder(this@BillOfMaterials.licenses.of(library))
        properties = library.programs.map { Property("badlog:program", it) }
    }

    private fun javaComponent() = Component().apply {
        type = Component.Type.PLATFORM
        group = java.first
        name = "OpenJDK"
        version = java.second
        bomRef = "openjdk@$version"
        licenses = LicenseChoice().apply { expression = Expression("GPL-2.0-only WITH Classpath-exception-2.0") }
        properties = listOf("badlog", "badlog-viewer").map { Property("badlog:program", it) }
    }
}

private fun Component.licensedUnder(names: List<String>) {
    licenses = LicenseChoice()
    for (name in names) {
        val known = LicenseResolver.resolve(name, false)?.licenses?.firstOrNull()
        licenses.addLicense(known ?: License().also { it.name = name })
    }
}

/** Returns the SHA-256 of [bytes], in 64 hexadecimal digits. */
internal fun sha256Of(bytes: ByteArray): String = HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes))

private const val MILLIS = 1_000L
