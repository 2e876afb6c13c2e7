package badlog.release

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.ObjectMapper
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.cyclonedx.Version
import org.cyclonedx.parsers.JsonParser
import java.io.File

class BillOfMaterialsSpec : FunSpec({
    val folder = tempFolder()
    val licenses = Licenses(mapOf("org.parented" to listOf("Apache-2.0")))

    fun library(group: String, license: String?, jar: String = "thing-1.0.jar"): ShippedLibrary {
        val place = File(folder, group).apply { mkdirs() }
        val file = File(place, jar).apply { writeText("the jar of $group") }
        val pom = File(place, "thing-1.0.pom")
        val named = license?.let { "<licenses><license><name>$it</name></license></licenses>" }.orEmpty()
        pom.writeText("<project><groupId>$group</groupId>$named</project>")
        return ShippedLibrary(group, "thing", "1.0", file, pom, listOf("badlog"))
    }

    fun bill(vararg libraries: ShippedLibrary) = BillOfMaterials("3.0.0", 1_780_000_000, "Somebody" to "17.0.15+6", libraries.toList(), licenses).json()

    fun componentIn(bill: String): JsonNode = ObjectMapper().readTree(bill)["components"].first { it["name"].asText() == "thing" }

    test("the bill of materials is valid CycloneDX") {
        val file = File(folder, "bill.json").apply { writeText(bill(library("org.example", "MIT"), library("org.parented", null))) }
        JsonParser().validate(file, Version.VERSION_16).map { it.message }.shouldBeEmpty()
    }

    test("a library has its address, its license by the SPDX name, its checksum and its programs") {
        val component = componentIn(bill(library("org.example", "The Apache Software License, Version 2.0")))
        component["purl"].asText() shouldBe "pkg:maven/org.example/thing@1.0"
        component["licenses"].single()["license"]["id"].asText() shouldBe "Apache-2.0"
        component["hashes"].single()["content"].asText() shouldBe sha256Of("the jar of org.example".encodeToByteArray())
        component["properties"].single()["value"].asText() shouldBe "badlog"
    }

    test("libraries for different systems are distinguished by their classifiers") {
        componentIn(bill(library("org.native", "MIT", "thing-1.0-linux-x86_64.jar")))["purl"].asText() shouldContain "?classifier=linux-x86_64"
    }

    test("a license from a parent POM is looked up, and an unknown one stops the release") {
        componentIn(bill(library("org.parented", null)))["licenses"].single()["license"]["id"].asText() shouldBe "Apache-2.0"
        shouldThrow<IllegalArgumentException> { bill(library("org.unknown", null)) }.message shouldContain "org.unknown:thing names no license"
    }

    test("the same libraries of the same commit make the same bytes") {
        val library = library("org.example", "MIT")
        bill(library) shouldBe bill(library)
    }

    test("a library in two programs is listed once") {
        fun lines(program: String) = listOf("library", "description").map { "$program\t$it\torg.example\tthing\t1.0\t/lib/thing-1.0.jar" }
        shippedLibraries(lines("badlog") + lines("badlog-viewer")).single().programs shouldBe listOf("badlog", "badlog-viewer")
    }
})
