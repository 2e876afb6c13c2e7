package badlog.viewer.panel

import badlog.core.analysis.Folder
import badlog.viewer.state.Action
import badlog.viewer.state.Request
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import badlog.core.recording.Value as KnownValue

class MetadataPanelSpec : FunSpec({
    fun folder(name: String, vararg values: Pair<String, String>) = Folder(name, values.map { (key, text) -> KnownValue(key, text) }, emptyList(), emptyList())

    val folders = listOf(folder("", "Event Name" to "OHCL"), folder("Arm", "Arm/Gain" to "0.5", "Arm/Note" to ""))

    fun Part.values() = (this as Rows).rows.map { it as Value }

    test("values are below their folder, which can be folded; those of no folder have no title") {
        val (root, arm) = metadataPanel(folders, "", emptyMap())
        root.values().map { it.name to it.text } shouldContainExactly listOf("Event Name" to "OHCL")
        arm.shouldBeInstanceOf<Fold>().run { title to isOpen } shouldBe ("Arm" to true)
        arm.parts.single().values().map { it.name to it.text } shouldContainExactly listOf("Gain" to "0.5", "Note" to "empty")
        (metadataPanel(folders, "", mapOf(arm.key to false))[1] as Fold).isOpen shouldBe false
    }

    test("a search finds names and texts; nothing is a sentence") {
        (metadataPanel(folders, "gain", emptyMap()).single() as Fold).parts.single().values().map { it.name } shouldContainExactly listOf("Gain")
        (metadataPanel(folders, "gain", mapOf("value-folder Arm" to false)).single() as Fold).isOpen shouldBe true
        (metadataPanel(folders, "gone", emptyMap()).single() as Paragraph).text shouldBe "Nothing matches “gone”."
        (metadataPanel(emptyList<Folder>(), "", emptyMap()).single() as Paragraph).text shouldBe "This log has no metadata: its header is empty."
    }

    test("a value's text is copied as it was written") {
        val listed = (metadataPanel(folders, "", emptyMap()).last() as Fold).parts.single().values()
        val copies = listed.map { it.tools.single().action.shouldBeInstanceOf<Action.Ask>().request }
        copies.map { it.shouldBeInstanceOf<Request.Copy>().text() } shouldContainExactly listOf("0.5", "")
    }
})
