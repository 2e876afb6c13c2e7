package badlog.site

import org.commonmark.ext.gfm.tables.TableCell
import org.commonmark.node.AbstractVisitor
import org.commonmark.node.Code
import org.commonmark.node.CustomNode
import org.commonmark.node.FencedCodeBlock
import org.commonmark.node.HardLineBreak
import org.commonmark.node.Heading
import org.commonmark.node.IndentedCodeBlock
import org.commonmark.node.ListItem
import org.commonmark.node.Node
import org.commonmark.node.Paragraph
import org.commonmark.node.SoftLineBreak
import org.commonmark.node.Text

/** Returns the text of [node] without markup; code is included if [includesCode]. */
internal fun plainText(node: Node, includesCode: Boolean = true): String {
    val text = StringBuilder()
    node.accept(object : AbstractVisitor() {
        override fun visit(node: Text) {
            text.append(node.literal)
        }

        override fun visit(code: Code) = code(code.literal)

        override fun visit(block: FencedCodeBlock) = code(block.literal)

        override fun visit(block: IndentedCodeBlock) = code(block.literal)

        override fun visit(lineBreak: SoftLineBreak) = space()

        override fun visit(lineBreak: HardLineBreak) = space()

        override fun visit(paragraph: Paragraph) {
            visitChildren(paragraph)
            space()
        }

        override fun visit(heading: Heading) {
            visitChildren(heading)
            space()
        }

        override fun visit(item: ListItem) {
            visitChildren(item)
            space()
        }

        override fun visit(node: CustomNode) {
            visitChildren(node)
            if (node is TableCell) space()
        }

        private fun space() {
            text.append(' ')
        }

        private fun code(literal: String) {
            text.append(if (includesCode) literal else "…")
        }
    })
    return text.toString().trim()
}
