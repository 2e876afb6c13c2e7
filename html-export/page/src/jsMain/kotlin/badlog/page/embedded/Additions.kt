package badlog.page.embedded

import badlog.protocol.PageAdditions
import badlog.protocol.fromJson
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.boardLayoutOf
import kotlinx.browser.document
import org.w3c.dom.Element
import org.w3c.dom.asList
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Returns the page's content besides the recording.
 *
 * Null if this browser cannot read it, for example because it is too long for a string.
 */
internal fun findAdditions(): PageAdditions? {
    val element = document.getElementById("additions") ?: return PageAdditions()
    return try {
        PageAdditions.fromJson(element.textContent.orEmpty())
    } catch (problem: Throwable) {
        console.error(problem)
        null
    }
}

/**
 * The layout with which the page begins.
 *
 * @property board its graphs; null if there are none.
 * @property formulas its formulas.
 * @property problem the reason why the layout cannot be used, as a sentence; null if it can.
 */
internal class GivenLayout private constructor(val board: Board?, val formulas: List<String>, val problem: String?) {
    companion object {
        /** Returns the layout in [text], a layout file; null means no layout. */
        fun of(text: String?): GivenLayout = try {
            val layout = text?.let { boardLayoutOf("The layout of this page", it) }
            GivenLayout(layout?.board, layout?.formulas.orEmpty(), null)
        } catch (e: BoardException) {
            GivenLayout(null, emptyList(), e.message)
        }
    }
}

/** Promises the files of the compared logs that this page contains; rejected if one was damaged. */
internal fun comparedFiles(): Promise<List<File>> {
    val files = document.querySelectorAll("script.compared").asList().map { node ->
        val element = node.unsafeCast<Element>()
        val name = element.getAttribute("data-name").orEmpty()
        EmbeddedFile(element).inflated().then { File(arrayOf<dynamic>(it), name).also { file -> file.carrier = element } }
    }
    return Promise.all(files.toTypedArray()).then { it.toList() }
}

/** The script element of this page that contains the file; null for a file from elsewhere. */
internal var File.carrier: Element?
    get() = asDynamic().carrier as Element?
    set(value) {
        asDynamic().carrier = value
    }
