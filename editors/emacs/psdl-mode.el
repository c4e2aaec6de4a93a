;;; psdl-mode.el --- Scene programs in Emacs -*- lexical-binding: t -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "28.1") (eglot "1.9"))
;; Keywords: languages

;;; Commentary:

;; A major mode for PSDL on top of Python's, and `psdl lsp' through eglot.  Put this file into your `load-path' and say
;;     (require 'psdl-mode)
;;     (add-hook 'psdl-mode-hook #'eglot-ensure)
;; Then \\[psdl-fix] corrects the layout errors of the region, or of the whole program.

;;; Code:

(require 'python)
(require 'eglot)
(require 'jsonrpc)

(defgroup psdl nil
  "Scene programs."
  :group 'languages)

(defcustom psdl-server-command '("psdl" "lsp")
  "The program that serves psdl buffers, and its arguments."
  :type '(repeat string))

(defvar psdl-font-lock-keywords
  `((,(rx symbol-start (or "Object" "Door" "Window" "Vec") symbol-end) . font-lock-type-face)
    (,(rx symbol-start
          (or "set_title" "set_size" "set_floor_asset" "set_wall_asset" "set_coordinate_frame" "opposite" "random_direction")
          symbol-end)
     . font-lock-builtin-face)
    (,(rx symbol-start
          (or "X_MAX" "X_MIN" "Y_MAX" "Y_MIN" "X_POS" "X_NEG" "Y_POS" "Y_NEG"
              "RIGHT_WALL" "TOP_WALL" "LEFT_WALL" "BOTTOM_WALL" "STANDING" "MOUNTED" "WALL_MOUNTED" "FLOATING")
          symbol-end)
     . font-lock-constant-face)
    (,(rx symbol-start "scene" symbol-end) . font-lock-variable-name-face)
    (,(rx "." (group (or "min" "max" "center" "facing" "width" "depth" "height")) symbol-end) 1 font-lock-keyword-face))
  "What psdl highlights beside Python.")

;;;###autoload
(define-derived-mode psdl-mode python-mode "PSDL"
  "A mode for scene programs: Python that places boxes."
  (setq-local python-shell-completion-native-enable nil)
  (font-lock-add-keywords nil psdl-font-lock-keywords))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.psdl\\'" . psdl-mode))

;; Before python-mode, from which ours is derived: the first match counts.
(add-to-list 'eglot-server-programs (cons 'psdl-mode (lambda (&rest _) psdl-server-command)))

(defun psdl--line (point)
  "The line of POINT, as the protocol counts, from its start."
  (list :line (1- (line-number-at-pos point t)) :character 0))

(defun psdl-fix (&optional beg end)
  "Correct the layout errors of the program, or of the lines of the region from BEG to END."
  (interactive (and (use-region-p) (list (region-beginning) (region-end))))
  (let* ((server (or (eglot-current-server) (user-error "No server runs for this buffer; try M-x eglot")))
         (uri (plist-get (eglot--TextDocumentIdentifier) :uri))
         (after (and end (list :line (line-number-at-pos end t) :character 0)))
         (arguments (if beg (vector uri (list :start (psdl--line beg) :end after)) (vector uri))))
    ;; What was typed last must be known there before it is corrected.
    (eglot--signal-textDocument/didChange)
    ;; The server answers with edits of its own.
    (jsonrpc-async-request server :workspace/executeCommand
                           (list :command (if beg "psdl.server.fixRange" "psdl.server.fixAll") :arguments arguments)
                           :success-fn #'ignore
                           :error-fn (lambda (err) (message "psdl: %s" (plist-get err :message))))))

(define-key psdl-mode-map (kbd "C-c C-x f") #'psdl-fix)

(provide 'psdl-mode)
;;; psdl-mode.el ends here
