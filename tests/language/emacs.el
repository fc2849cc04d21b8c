;;; What a user of Emacs does with glim --language-server, and what must come
;;; of it; run by tests/language/run, with the lines of README as init.el.
(package-initialize)
(load-file "init.el")
(require 'eglot)
(setq eglot-sync-connect 20
      eglot-confirm-server-initiated-edits nil)
(fset 'y-or-n-p (lambda (&rest _) t))

(defun must (truth words)
  (unless truth
    (message "emacs: not so: %s" words)
    (kill-emacs 1)))

(defun within (place text)
  (goto-char (point-min))
  (search-forward text)
  (backward-char place))

(defun diagnosed (count)
  (let ((turns 0))
    (while (and (< turns 100) (/= count (length (flymake-diagnostics))))
      (accept-process-output nil 0.1)
      (flymake-start)
      (setq turns (1+ turns))))
  (= count (length (flymake-diagnostics))))

(find-file "scene.pov")
(must (eq major-mode 'pov-mode) "the mode of README")
(unless (eglot-current-server) (apply #'eglot (eglot--guess-contact)))
(flymake-mode 1)
(must (diagnosed 1) "one mistake")
(within 0 "pigmnt")
(replace-match "pigment")
(eglot--signal-textDocument/didChange)
(must (diagnosed 0) "no mistake after it was typed away")

(within 2 "Ball(")
(must (string-match "A ball"
                    (plist-get (plist-get (jsonrpc-request
                                           (eglot-current-server)
                                           :textDocument/hover
                                           (eglot--TextDocumentPositionParams))
                                          :contents)
                               :value))
      "the macro's comment")
(must (string-match "part.inc"
                    (xref-location-group
                     (xref-item-location
                      (car (xref-backend-definitions 'eglot "Ball")))))
      "a jump to the include")
(within 1 "Size")
(eglot-rename "Width")
(within 0 "Ball(Width)")

(goto-char (point-max))
(insert "union {\nsphere { 0, 1 finish { dif } }\n}\n")
(search-backward "dif")
(forward-char 3)
(eglot--signal-textDocument/didChange)
(must (member "diffuse" (mapcar #'substring-no-properties
                                (all-completions "dif" (nth 2 (eglot-completion-at-point)))))
      "diffuse completes in finish")
(insert "fuse 1")
(eglot-format-buffer)
(goto-char (point-min))
(must (re-search-forward "^[ \t]+sphere" nil t) "indented")
(message "emacs is content")
(kill-emacs 0)
